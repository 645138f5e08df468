package org.u2sa.sim.file;

import java.util.Map;
import java.util.Optional;
import org.u2sa.device.port.Device;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.device.SimulatedDevice;

/**
 * A sensor of a vehicle file.
 *
 * @param kind its element
 * @param port kind of device that services see
 * @param service name of the only service that receives it; empty: every service of the port
 *     without a dedicated sensor, each with separate noise
 * @param delayS extra delay [s]
 * @param lost fraction of lost readings, 0…1
 * @param failsAtS time of the vehicle at which it fails permanently [s]; infinite for never
 * @param variables values of the services' variables that the sensor determines
 * @param place its position, if State Estimators need to know it: forward, right, down [m]
 * @param maker creates the device
 */
record SensorEntry(
    String kind,
    Class<? extends Device<?>> port,
    Optional<String> service,
    double delayS,
    double lost,
    double failsAtS,
    Map<String, Double> variables,
    Point place,
    Maker maker) {
  /** Creates a device for a vehicle. */
  @FunctionalInterface
  interface Maker {
    SimulatedDevice<?> make(Aboard vehicle);
  }

  /** Creates the device of one service. */
  SimulatedDevice<?> make(Aboard vehicle) {
    SimulatedDevice<?> device = maker.make(vehicle);
    device.degrade(delayS, lost, vehicle.streams().of("losses"));
    device.failAt(failsAtS, () -> vehicle.truth().get().timeS());
    return device;
  }
}
