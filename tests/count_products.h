/* Included ahead of all sources: -DHOLONOM_WITHOUT=holonom_without then asks count_products.c. */
extern int holonom_without;
