/**
 * Message infrastructure: types, fields, presence and CBOR form. The messages themselves are
 * elsewhere.
 */
package org.u2sa.messages.schema;
