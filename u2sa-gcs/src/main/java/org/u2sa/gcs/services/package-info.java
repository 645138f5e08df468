/**
 * Commands to list the services of a running system, find them by their data, and stop, restart and
 * swap them. The connection is in the remote package.
 */
package org.u2sa.gcs.services;
