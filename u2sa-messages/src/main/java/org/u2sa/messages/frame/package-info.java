/**
 * Points, reference frames and geodesy on WGS-84 (thesis 3.2.3.2): plain values that know nothing
 * of messages. Conversions of whole messages stand beside the messages, in {@link
 * org.u2sa.messages}.
 */
package org.u2sa.messages.frame;
