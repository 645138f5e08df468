package org.u2sa.service;

/** A sensor of the vehicle itself, such as a GPS or an IMU (thesis 3.2.2.4). Out: sensed-state. */
public abstract class ProprioceptiveSensor extends Sensor {
  /** See {@link Sensor#Sensor}: registers as a publisher of State Information. */
  protected ProprioceptiveSensor(ServiceContext context, String serviceName, double defaultRateHz) {
    super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, serviceName, defaultRateHz);
  }
}
