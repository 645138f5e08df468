package org.u2sa.gcs.services;

/**
 * One service feeds another.
 *
 * @param from who publishes
 * @param to who subscribes
 * @param channel the channel's name
 * @param type the narrower of the two types that they named for it
 */
record Feed(String from, String to, String channel, String type) {}
