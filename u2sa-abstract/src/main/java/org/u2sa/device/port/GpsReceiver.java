package org.u2sa.device.port;

/** A GNSS receiver: position and velocity over ground in {@link GpsFix}. */
public interface GpsReceiver extends Device<GpsFix> {}
