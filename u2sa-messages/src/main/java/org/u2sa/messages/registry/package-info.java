/**
 * The registry of standard messages. What a message is belongs to {@code messages.schema}, the
 * messages to their subjects.
 */
package org.u2sa.messages.registry;
