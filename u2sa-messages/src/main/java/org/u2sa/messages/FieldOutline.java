package org.u2sa.messages;

/** What all kinds of fields have in common, as the schema hands it to them. */
record FieldOutline(
    String owner, String name, String unit, FieldPresence presence, int slot, int bit, int since) {}
