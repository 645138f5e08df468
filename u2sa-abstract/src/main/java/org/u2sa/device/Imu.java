package org.u2sa.device;

/** An inertial measurement unit that knows its attitude: {@link Orientation}. */
public interface Imu extends Device<Orientation> {}
