/**
 * The messages of the data model (thesis 3.2.3, figures 5–13). Schema and codec are in {@code
 * schema}, shapes in {@code shape}. Services, channels and transports do not belong here.
 */
package org.u2sa.messages;
