package org.u2sa.device;

/** A pressure sensor under water: {@link Pressure} of the water. */
public interface DepthGauge extends Device<Pressure> {}
