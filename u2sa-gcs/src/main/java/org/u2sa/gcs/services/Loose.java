package org.u2sa.gcs.services;

/**
 * An end of a channel that has no other end.
 *
 * @param service whose it is
 * @param channel the channel's name
 * @param type the type that the service named
 */
record Loose(String service, String channel, String type) {}
