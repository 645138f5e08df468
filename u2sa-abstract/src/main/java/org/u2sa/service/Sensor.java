package org.u2sa.service;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Reads a sensor at a fixed rate and publishes the measurements (thesis 3.2.2.2). */
public abstract class Sensor extends PeriodicService {
  private record Names(
      @Variable(ifAbsentText = "")
          @Description(
              "Name of the sensor in its messages, unique in the system; empty: the service's name.")
          String sensorName) {}

  private final String sensorName;

  /**
   * See {@link PeriodicService#PeriodicService}. Registers as a publisher on the main channel of
   * the role: proprioceptive or exteroceptive sensor.
   */
  protected Sensor(
      ServiceContext context, ServiceRole role, String serviceName, double defaultRateHz) {
    super(context, role, serviceName, defaultRateHz);
    String configured = settings(Names.class).get().sensorName();
    sensorName = configured.isEmpty() ? getServiceName() : configured;
    registerPublisher(role.mainOutput());
  }

  /** The sensor's name, by which the State Estimator distinguishes its sources. */
  public final String sensorName() {
    return sensorName;
  }
}
