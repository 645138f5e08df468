package org.u2sa.device.port;

/** An underwater pressure sensor: {@link Pressure} of the water. */
public interface DepthGauge extends Device<Pressure> {}
