/**
 * The messages of the data model (thesis 3.2.3, figures 5–13). Schema and codec are in {@code
 * schema}, shapes in {@code shape}, commands in {@code command}, goals in {@code goal}; services,
 * channels and transports are elsewhere.
 */
package org.u2sa.messages;
