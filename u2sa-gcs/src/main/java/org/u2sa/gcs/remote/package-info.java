/**
 * The connection to a system in another process or on another host, and the registry of the systems
 * on this machine. The content of requests and orders belongs to sibling packages.
 */
package org.u2sa.gcs.remote;
