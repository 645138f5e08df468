/**
 * Commands to list the services of a running system, find them by their data, and stop, restart and
 * swap them. The observation of services is in {@code gcs.services}.
 */
package org.u2sa.cli.services;
