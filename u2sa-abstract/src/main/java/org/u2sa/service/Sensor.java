package org.u2sa.service;

import org.u2sa.interfaces.configuration.VariableDeclaration;

/**
 * A service that reads a sensor at a fixed rate and publishes what it measured (thesis 3.2.2.2).
 */
public abstract class Sensor extends PeriodicService {
  private static final VariableDeclaration<String> SENSOR_NAME =
      VariableDeclaration.text("SENSOR NAME")
          .ifAbsent("")
          .describedAs(
              "Name of the sensor in its messages, unique in the system; empty: the service's name.");

  private final String sensorName;

  Sensor(ServiceContext context, ServiceRole role, String serviceName, double defaultRateHz) {
    super(context, role, serviceName, defaultRateHz);
    String configured = getVariable(SENSOR_NAME);
    sensorName = configured.isEmpty() ? getServiceName() : configured;
  }

  /** The sensor's name, by which the State Estimator tells the sources of its data apart. */
  public final String sensorName() {
    return sensorName;
  }
}
