/**
 * How commands join a system that runs in another process or on another host: shared options, the
 * connection, and requests to its services. The content of requests and orders belongs to each
 * command.
 */
package org.u2sa.gcs.remote;
