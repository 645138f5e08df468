package org.u2sa.service.directory;

/**
 * A service that has to do with a type of data, and how.
 *
 * @param service the service
 * @param offer the channel and the type that it named
 * @param certain whether all that travels on the channel is of the type asked for; otherwise the
 *     type is a subclass of the channel's, so that messages of it may travel there among others
 */
public record Found(KnownService service, DataOffer offer, boolean certain) {}
