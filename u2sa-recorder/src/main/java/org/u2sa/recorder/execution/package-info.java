/**
 * Executions of services: what passed between a service and the world, how it is kept in a
 * recording, and how the service is executed again on it. No commands, and nothing of how a system
 * is launched.
 */
package org.u2sa.recorder.execution;
