package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.u2sa.device.port.Device;
import org.u2sa.device.port.MotorController;
import org.u2sa.device.port.Servo;
import org.u2sa.device.port.Thruster;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.device.SimulatedMotors;
import org.u2sa.sim.device.SimulatedTraffic;
import org.u2sa.sim.device.VehicleServo;
import org.u2sa.sim.device.VehicleThruster;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.ground.GroundVehicle;
import org.u2sa.sim.payload.SimulatedSwitch;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.RunningVehicle;
import org.u2sa.sim.vehicle.VehicleRun;

/**
 * Supplies the services of a system file with a simulated vehicle's devices, regardless of the
 * drivers that their configurations name. Sensors are found by port and service name, actuators by
 * their names. Each service has its own noise. Variables that the device determines, such as a
 * receiver's DELAY, are set unless the service's file sets them.
 */
public final class VehicleDevices implements ServiceContext.DeviceSource {
  private static final String ACTUATOR_NAME = "ACTUATOR NAME";
  private static final String COUNTS = "COUNTS PER TURN";
  private static final double USUAL_COUNTS = 2_000.0;
  private static final double MOTOR_TIMEOUT_S = 0.5;

  private final VehicleFile file;
  private final RunningVehicle run;
  private final long seed;
  private Supplier<List<SimulatedTraffic.Other>> traffic = List::of;
  private final Map<String, SimulatedSwitch> switches = new ConcurrentHashMap<>(); // by service
  private final Map<String, Point> mounted = new ConcurrentHashMap<>(); // by sensor's name
  private final Map<String, NoiseStreams> noise = new HashMap<>(); // by service

  /**
   * @param run the vehicle of the file, in its world
   * @param seed seed of the run, for the noise
   */
  public VehicleDevices(VehicleFile file, RunningVehicle run, long seed) {
    this.file = file;
    this.run = run;
    this.seed = seed;
  }

  /** Supplies traffic receivers with the moving objects around the vehicle. */
  public VehicleDevices traffic(Supplier<List<SimulatedTraffic.Other>> around) {
    traffic = around;
    return this;
  }

  /** Makes a service's sensor use these random numbers instead of its own stream. */
  public VehicleDevices noise(String service, NoiseStreams streams) {
    noise.put(service, streams);
    return this;
  }

  @Override
  public <D> Optional<D> device(
      Class<D> port, String service, XmlConfiguration variables, Clock clock) {
    if (port == Thruster.class) {
      return Optional.of(port.cast(thruster(service, variables, clock)));
    }
    if (port == Servo.class && isOfTheModel(service, variables)) {
      return Optional.of(port.cast(servo(service, variables)));
    }
    if (port == MotorController.class) {
      return Optional.of(port.cast(motors(service, variables, clock)));
    }
    if (port == VehicleRun.class && run instanceof VehicleRun.Readers readers) {
      return Optional.of(port.cast(readers.owned()));
    }
    return SensorKinds.isKnown(port)
        ? Optional.of(port.cast(sensor(port, service, variables, clock)))
        : Optional.empty();
  }

  private static Optional<String> stated(XmlConfiguration service, String variable) {
    return service.enumerateFields().stream()
        .filter(each -> each.getKey().equals(variable))
        .map(each -> each.getValue().toString())
        .filter(text -> !text.isEmpty())
        .findFirst();
  }

  private static void unlessStated(XmlConfiguration service, String variable, double value) {
    if (stated(service, variable).isEmpty()) {
      service.override(variable, value);
    }
  }

  private Device<?> sensor(Class<?> port, String name, XmlConfiguration service, Clock clock) {
    List<SensorEntry> fitting =
        file.sensors().stream()
            .filter(each -> each.port() == port)
            .filter(each -> each.service().isEmpty() || each.service().get().equals(name))
            .collect(Collectors.toList());
    SensorEntry entry =
        fitting.stream()
            .filter(each -> each.service().isPresent())
            .findFirst()
            .or(() -> fitting.stream().findFirst())
            .orElseThrow(() -> none(name, port.getSimpleName()));
    for (Map.Entry<String, Double> each : entry.variables().entrySet()) {
      unlessStated(service, each.getKey(), each.getValue());
    }
    mounted.put(stated(service, "SENSOR NAME").orElse(name), entry.place());
    Device<?> device =
        entry.make(Aboard.of(run, clock::micros, () -> traffic.get(), streams(name)));
    if (device instanceof SimulatedSwitch output) {
      switches.put(name, output);
    }
    return device;
  }

  /**
   * Positions on the vehicle of the services' receivers, IMUs and velocity logs, by the sensors'
   * names: forward, right, down [m]. Thread-safe.
   */
  public Map<String, Point> mounted() {
    return Map.copyOf(mounted);
  }

  /** Level of a service's switched payload [%]; 0 if it has none. Thread-safe. */
  public double switchPercent(String service) {
    return Optional.ofNullable(switches.get(service)).map(SimulatedSwitch::percent).orElse(0.0);
  }

  private BadInputException none(String service, String port) {
    List<String> all = new ArrayList<>();
    for (SensorEntry each : file.sensors()) {
      all.add(
          "<"
              + each.kind()
              + each.service().map(only -> " service=\"" + only + "\"").orElse("")
              + ">");
    }
    all.addAll(file.model().actuators());
    return new BadInputException(
        String.format(
            "%s: service \"%s\" needs a %s, which the vehicle lacks; it has %s",
            file.origin(), service, port, String.join(", ", all)));
  }

  private NoiseStreams streams(String service) {
    return noise.containsKey(service)
        ? noise.get(service)
        : new NoiseStreams(new NoiseStreams(seed).of("sensor " + service).nextLong());
  }

  private Supplier<GroundState> wheels(Clock clock) {
    return () -> run.read(clock.micros(), vehicle -> ((GroundVehicle) vehicle).state());
  }

  private Thruster thruster(String service, XmlConfiguration variables, Clock clock) {
    String name = stated(variables, ACTUATOR_NAME).orElse(service);
    VehicleModel model = file.model();
    if (model.actuators().contains(name)
        && model.travelRad(name).isEmpty()
        && model.wheels().isEmpty()
        && run instanceof VehicleRun commanded) {
      VehicleThruster thruster = new VehicleThruster(commanded, name);
      thruster.failAt(model.failsAtS(name), () -> run.at(clock.micros()).timeS());
      return thruster;
    }
    throw none(service, "Thruster \"" + name + "\"");
  }

  /** Whether a servo moves the vehicle's own control surface or steering, not a payload. */
  private boolean isOfTheModel(String service, XmlConfiguration variables) {
    String name = stated(variables, ACTUATOR_NAME).orElse(service);
    return file.model().actuators().contains(name)
        || file.sensors().stream().noneMatch(each -> each.port() == Servo.class);
  }

  private Servo servo(String service, XmlConfiguration variables) {
    String name = stated(variables, ACTUATOR_NAME).orElse(service);
    OptionalDouble travel = file.model().travelRad(name);
    if (travel.isPresent() && run instanceof VehicleRun commanded) {
      unlessStated(variables, "TRAVEL", travel.getAsDouble());
      return new VehicleServo(commanded, name, travel.getAsDouble(), file.model().lowest(name));
    }
    throw none(service, "Servo \"" + name + "\"");
  }

  private MotorController motors(String name, XmlConfiguration service, Clock clock) {
    VehicleModel.Wheels wheels =
        file.model().wheels().orElseThrow(() -> none(name, "MotorController"));
    if (!(run instanceof VehicleRun commanded)) {
      throw none(name, "MotorController beside the IOIO board");
    }
    unlessStated(service, COUNTS, USUAL_COUNTS);
    unlessStated(service, "WHEEL DIAMETER", 2.0 * wheels.radiusM());
    unlessStated(service, "TRACK", wheels.trackM());
    List<String> sides = file.model().actuators();
    return new SimulatedMotors(
        Double.parseDouble(stated(service, COUNTS).orElseThrow()),
        MOTOR_TIMEOUT_S,
        streams(name),
        wheels(clock),
        (command, now, until) -> {
          commanded.command(now, sides.get(0), command.first(), until);
          commanded.command(now, sides.get(1), command.second(), until);
        });
  }
}
