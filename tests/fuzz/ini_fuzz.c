/* Any bytes as an INI file: read without harm; each entry has a line, a section, a key, a value. */
#include "fuzz.h"
#include "sys/ini.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    FILE *f = bytes(data, size);
    struct ini ini;
    struct why why = {""};
    enum status s = ini_read(f, "fuzz", &ini, &why);

    check((s == SW_OK) == (why.text[0] == '\0'));
    for (int i = 0; s == SW_OK && i < ini.n; i++) {
        const struct ini_entry *e = &ini.entry[i];

        check(e->line > 0 && e->section[0] && e->key[0] && e->value[0]);
        check(ini_find(&ini, e->section, e->key) == e); /* no double keys */
    }
    ini_free(&ini);
    fclose(f);
    return 0;
}
