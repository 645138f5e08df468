/** CBOR (RFC 8949) as the messages use it: items, limits, typed arrays and the two wire forms. */
package org.u2sa.messages.cbor;
