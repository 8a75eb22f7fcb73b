/* Included ahead of all sources: -DHOLONOM_WITHOUT=holonom_without, and the like, then ask
   count_products.c. */
extern int holonom_without, holonom_energy_decides;
