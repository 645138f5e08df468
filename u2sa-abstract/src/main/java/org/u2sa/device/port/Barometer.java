package org.u2sa.device.port;

/** A barometer: static {@link Pressure} of the air. */
public interface Barometer extends Device<Pressure> {}
