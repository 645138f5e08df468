package org.u2sa.service;

/**
 * A sensor of the environment, such as a range finder or a camera (thesis 3.2.2.3). Out:
 * sensed-objects, or scans of scanning range finders.
 */
public abstract class ExteroceptiveSensor extends Sensor {
  /** See {@link Sensor#Sensor}: registers as a publisher of Object Descriptions. */
  protected ExteroceptiveSensor(ServiceContext context, String serviceName, double defaultRateHz) {
    super(context, ServiceRole.EXTEROCEPTIVE_SENSOR, serviceName, defaultRateHz);
  }
}
