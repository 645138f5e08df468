package org.u2sa.device.port;

/** A compass: magnetic or true {@link Heading}. */
public interface Compass extends Device<Heading> {}
