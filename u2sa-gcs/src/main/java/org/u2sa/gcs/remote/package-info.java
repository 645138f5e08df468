/**
 * The connection to a system that runs in another process or on another host, and which systems run
 * on this machine. The content of requests and orders belongs to sibling packages.
 */
package org.u2sa.gcs.remote;
