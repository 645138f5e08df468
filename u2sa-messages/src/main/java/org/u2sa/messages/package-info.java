/**
 * The data model (thesis 3.2.3, figures 5–13): messages, their schema, and the codec that both
 * share. Services, channels and transports do not belong here.
 */
package org.u2sa.messages;
