/** Routing of messages to subscribers, and retained messages. */
package org.u2sa.core.communication.routing;
