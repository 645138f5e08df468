/**
 * How commands join a system that runs in another process or on another host: the options that they
 * share, the connection, and questions to its services. What a command asks or orders belongs to
 * the command.
 */
package org.u2sa.gcs.remote;
