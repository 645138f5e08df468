package org.u2sa.device;

/** An underwater pressure sensor: {@link Pressure} of the water. */
public interface DepthGauge extends Device<Pressure> {}
