/**
 * Points, reference frames and geodesy on WGS-84 (thesis 3.2.3.2): plain values without knowledge
 * of messages. Conversions of whole messages are in {@link org.u2sa.messages}.
 */
package org.u2sa.messages.frame;
