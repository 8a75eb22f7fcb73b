#include "small.h"

#include "resources.h"

#include <string.h>

#ifdef HOLONOM_MODEL /* the model is compiled in, as HOLONOM_MODEL_BYTES bytes */

#include HOLONOM_MODEL

hm_bytes hm_model_bytes(const char *folder, int32_t is_uri, hm_text *why)
{
    (void)folder, (void)is_uri, (void)why;
    return (hm_bytes){hm_model, HOLONOM_MODEL_BYTES, 0};
}

#else

#include <stdio.h>
#include <stdlib.h>
#ifdef _WIN32
#include <windows.h>
#endif

enum { LONGEST_PATH = 4096, MOST_BYTES = 1 << 30 };
static const char NAME[] = "/model.bin";

static int digit_of(char c)
{
    return c >= '0' && c <= '9'                 ? c - '0'
           : (c | 32) >= 'a' && (c | 32) <= 'f' ? (c | 32) - 'a' + 10
                                                : -1;
}

/* Whether a text begins with these small letters and signs; capitals are as good. */
static int begins(const char *text, const char *with)
{
    for (; *with; text++, with++)
        if (*text != *with && (*with < 'a' || (*text | 32) != *with)) return 0;
    return 1;
}

/* Path of file:///a%20b, file:/a, file://localhost/a, file:///C:/a and, on Windows,
   file://server/share; 0 if it is none. Schemes and hosts have no case (RFC 3986, 6.2.2.1). */
static int path_of(const char *uri, char *path, size_t room)
{
    size_t used = 0;
    if (!begins(uri, "file:")) return 0;
    uri += 5;
    if (begins(uri, "//localhost/")) uri += 11;
    else if (!strncmp(uri, "///", 3)) uri += 2;
#ifdef _WIN32
    if (uri[0] == '/' && uri[1] && (uri[2] == ':' || uri[2] == '|')) uri++; /* /C:/a */
#else
    else if (!strncmp(uri, "//", 2)) return 0; /* another machine */
#endif
    for (; *uri && used + 1 < room; used++) {
        const int is_code = uri[0] == '%' && digit_of(uri[1]) >= 0 && digit_of(uri[2]) >= 0;
        path[used] = is_code ? (char)(16 * digit_of(uri[1]) + digit_of(uri[2])) : *uri;
        uri += is_code ? 3 : 1;
    }
    path[used] = 0;
    return !*uri;
}

static FILE *opened(const char *path)
{
#ifdef _WIN32
    /* The prefix takes paths of more than 260 characters; it wants backslashes. */
    wchar_t wide[LONGEST_PATH + 8] = L"\\\\?\\", *own = wide + 4;
    if (!MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, path, -1, own, LONGEST_PATH))
        return NULL;
    for (wchar_t *c = own; *c; c++)
        if (*c == L'/') *c = L'\\';
    return _wfopen(own[1] == L':' ? wide : own,
                   L"rb"); /* a share, or a path from the present folder, is taken as it is */
#else
    return fopen(path, "rb");
#endif
}

/* All bytes of an open file; begin is NULL if they cannot be read. */
static hm_bytes read_from(FILE *file)
{
    hm_bytes found = {NULL, 0, 1};
    const long size = fseek(file, 0, SEEK_END) ? -1 : ftell(file);
    if (size <= 0 || size > MOST_BYTES) return found;
    void *data = malloc((size_t)size);
    rewind(file);
    if (data && fread(data, 1, (size_t)size, file) == (size_t)size)
        found.begin = data, found.length = size;
    else free(data);
    return found;
}

hm_bytes hm_model_bytes(const char *folder, int32_t is_uri, hm_text *why)
{
    char path[LONGEST_PATH];
    const size_t room = sizeof path - sizeof NAME, given = folder ? strlen(folder) : 0;
    hm_bytes found = {NULL, 0, 0};
    if (!given || (is_uri ? !path_of(folder, path, room) : given >= room)) {
        hm_say(why, "instantiate: %s is no %s of a folder of resources", given ? folder : "NULL",
               is_uri ? "file URI" : "path");
        return found;
    }
    if (!is_uri) memcpy(path, folder, given + 1);
    size_t length = strlen(path);
    while (length && (path[length - 1] == '/' || path[length - 1] == '\\')) length--;
    memcpy(path + length, NAME, sizeof NAME);
    FILE *file = opened(path);
    if (file) {
        found = read_from(file);
        fclose(file);
    }
    if (!found.begin) hm_say(why, "instantiate: %s cannot be read", path);
    return found;
}

#endif

#include "small.h"
