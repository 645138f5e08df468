package org.u2sa.device;

/** A satellite receiver: position and velocity over ground in {@link GpsFix}. */
public interface GpsReceiver extends Device<GpsFix> {}
