/**
 * Options of commands that join a running system. The connection itself is in {@code gcs.remote}.
 */
package org.u2sa.cli.remote;
