package org.u2sa.sim.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.sim.device.SerialInstrument;
import org.u2sa.sim.ioio.Pins;
import org.u2sa.sim.ioio.PulseTrain;
import org.u2sa.sim.ioio.ServoInput;
import org.u2sa.sim.vehicle.VehicleRun;

/**
 * Default pins for a vehicle without an {@code <ioio>} element: actuators on servo pulses, in their
 * order, a GPS receiver and a compass on UARTs, a radio switch set to automatic, and 12 V behind a
 * 5:1 divider. Actuators without pulses receive no signal.
 */
public final class VehiclePins implements Pins {
  private static final int[] ACTUATOR_PINS = {10, 11, 12, 3, 4, 5, 27, 28, 29}; // PWM modules: 9
  private static final int GPS_RECEIVE = 6;
  private static final int GPS_TRANSMIT = 7;
  private static final int COMPASS_RECEIVE = 13;
  private static final int COMPASS_TRANSMIT = 14;
  private static final int RADIO_SWITCH = 35;
  private static final int BATTERY = 40;
  private static final double BATTERY_V = 12.0 / 5.0;
  private static final PulseTrain AUTOMATIC = new PulseTrain(1.9e-3, 0.02);

  private record Line(int receive, int transmit, SerialInstrument device) {}

  private final VehicleRun run;
  private final Map<Integer, String> actuators = new LinkedHashMap<>(); // by pin
  private final Map<Integer, ServoInput> inputs = new LinkedHashMap<>();
  private final Map<String, Double> commands = new ConcurrentHashMap<>();
  private final List<Line> lines;
  private long beginMicros = -1;
  private long nowMicros;

  /**
   * @param seed seed of the noise
   * @throws BadInputException if the vehicle has more actuators than a board can drive
   */
  public VehiclePins(VehicleFile file, VehicleRun run, long seed) {
    this.run = run;
    List<String> names = file.model().actuators();
    if (names.size() > ACTUATOR_PINS.length) {
      throw new BadInputException(
          String.format(
              "%s: has %d actuators; an IOIO drives at most %d",
              file.origin(), names.size(), ACTUATOR_PINS.length));
    }
    for (int i = 0; i < names.size(); i++) {
      actuators.put(ACTUATOR_PINS[i], names.get(i));
      inputs.put(ACTUATOR_PINS[i], new ServoInput(file.model().lowest(names.get(i)) >= 0.0));
    }
    Map<String, SerialInstrument> all = VehicleInstruments.of(file, run, () -> nowMicros, seed);
    lines =
        Stream.of(
                new Line(GPS_RECEIVE, GPS_TRANSMIT, all.get("gps")),
                new Line(COMPASS_RECEIVE, COMPASS_TRANSMIT, all.get("compass")))
            .filter(line -> line.device() != null)
            .toList();
  }

  public Map<Integer, String> actuators() {
    return actuators;
  }

  /** The latest commands, in the order of the actuators; NaN without a signal. Thread-safe. */
  public Map<String, Double> commands() {
    Map<String, Double> inOrder = new LinkedHashMap<>();
    actuators.values().forEach(name -> inOrder.put(name, commands.getOrDefault(name, Double.NaN)));
    return inOrder;
  }

  @Override
  public void advance(long micros) {
    if (beginMicros < 0) {
      beginMicros = micros;
    }
    long before = since(nowMicros);
    nowMicros = micros;
    run.at(micros);
    inputs.forEach(this::apply);
    lines.forEach(line -> line.device().advance(since(micros), before));
  }

  private void apply(int pin, ServoInput input) {
    String actuator = actuators.get(pin);
    double value = input.command(nowMicros);
    Double before = commands.put(actuator, value);
    if (before == null || Double.compare(before, value) != 0) {
      run.command(nowMicros, actuator, value);
    }
  }

  private long since(long micros) {
    return Math.max(0L, micros - beginMicros);
  }

  @Override
  public void driven(int pin, PulseTrain pulses) {
    if (inputs.containsKey(pin)) {
      inputs.get(pin).take(pulses, nowMicros);
    }
  }

  @Override
  public void released(int pin) {
    driven(pin, PulseTrain.NONE);
  }

  @Override
  public void transmitted(int pin, int baud, byte[] bytes, int length) {
    for (Line line : lines) {
      if (line.transmit() == pin) {
        line.device().accept(since(nowMicros), baud, bytes, length);
      }
    }
  }

  @Override
  public int received(int pin, int baud, byte[] buffer) {
    for (Line line : lines) {
      if (line.receive() == pin) {
        return line.device().take(since(nowMicros), baud, buffer);
      }
    }
    return 0;
  }

  @Override
  public double volts(int pin) {
    return pin == BATTERY ? BATTERY_V : 0.0;
  }

  @Override
  public PulseTrain pulses(int pin) {
    return pin == RADIO_SWITCH ? AUTOMATIC : PulseTrain.NONE;
  }
}
