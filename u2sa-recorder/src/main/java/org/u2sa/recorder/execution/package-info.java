/**
 * Executions of services: recording all interactions of a service, and re-executing it from them.
 * Contains no commands and no launching of systems.
 */
package org.u2sa.recorder.execution;
