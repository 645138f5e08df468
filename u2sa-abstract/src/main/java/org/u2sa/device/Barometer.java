package org.u2sa.device;

/** A barometer: static {@link Pressure} of the air. */
public interface Barometer extends Device<Pressure> {}
