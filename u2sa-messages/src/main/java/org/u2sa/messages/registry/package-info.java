/**
 * The registry of standard messages. The message model belongs to {@code messages.schema}, message
 * classes to the packages of their subjects.
 */
package org.u2sa.messages.registry;
