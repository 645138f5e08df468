package org.u2sa.drivers.ioio;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.sim.ioio.IoioBoard;
import org.u2sa.sim.ioio.IoioFirmware;
import org.u2sa.sim.ioio.Pins;
import org.u2sa.sim.ioio.PulseTrain;

/** A bench with a simulated board on it: writes down what the pins give, gives what a test sets. */
final class Bench implements Pins {
  private final Map<Integer, List<PulseTrain>> driven = new HashMap<>();
  private final Map<Integer, Boolean> levels = new HashMap<>();
  private final Map<Integer, ByteArrayOutputStream> toDevice = new HashMap<>();
  private final Map<Integer, ByteArrayOutputStream> fromDevice = new HashMap<>();
  private final Map<Integer, Double> volts = new HashMap<>();
  private final Map<Integer, PulseTrain> pulses = new HashMap<>();

  final IoioFirmware firmware = new IoioFirmware(IoioBoard.OTG, this);

  @Override
  public synchronized void driven(int pin, PulseTrain train) {
    history(pin).add(train);
    levels.remove(pin);
  }

  @Override
  public synchronized void driven(int pin, boolean high) {
    history(pin).add(PulseTrain.NONE);
    levels.put(pin, high);
  }

  @Override
  public synchronized void released(int pin) {
    history(pin).add(PulseTrain.NONE);
    levels.remove(pin);
  }

  private List<PulseTrain> history(int pin) {
    return driven.computeIfAbsent(pin, any -> new ArrayList<>());
  }

  @Override
  public synchronized void transmitted(int pin, int baud, byte[] bytes, int length) {
    toDevice.computeIfAbsent(pin, any -> new ByteArrayOutputStream()).write(bytes, 0, length);
  }

  @Override
  public synchronized int received(int pin, int baud, byte[] buffer) {
    ByteArrayOutputStream waiting = fromDevice.remove(pin);
    if (waiting == null) {
      return 0;
    }
    byte[] bytes = waiting.toByteArray();
    int count = Math.min(bytes.length, buffer.length);
    System.arraycopy(bytes, 0, buffer, 0, count);
    if (count < bytes.length) {
      send(pin, Arrays.copyOfRange(bytes, count, bytes.length));
    }
    return count;
  }

  @Override
  public synchronized double volts(int pin) {
    return volts.getOrDefault(pin, 0.0);
  }

  @Override
  public synchronized PulseTrain pulses(int pin) {
    return pulses.getOrDefault(pin, PulseTrain.NONE);
  }

  /** The device at a receive pin sends bytes. */
  synchronized void send(int pin, byte[] bytes) {
    fromDevice.computeIfAbsent(pin, any -> new ByteArrayOutputStream()).writeBytes(bytes);
  }

  /** The voltage at a pin from now on. */
  synchronized void volts(int pin, double value) {
    volts.put(pin, value);
  }

  /** The pulses that a receiver sends to a pin from now on. */
  synchronized void pulses(int pin, double widthS) {
    pulses.put(pin, widthS == 0.0 ? PulseTrain.NONE : new PulseTrain(widthS, 0.02));
  }

  /** Width of the pulses that a pin gives now [s], 0 if it gives none. */
  synchronized double width(int pin) {
    List<PulseTrain> all = history(pin);
    return all.isEmpty() ? 0.0 : all.get(all.size() - 1).widthS();
  }

  /** All pulses that a pin has given so far, in order. */
  synchronized List<PulseTrain> history(int pin, int from) {
    List<PulseTrain> all = history(pin);
    return new ArrayList<>(all.subList(Math.min(from, all.size()), all.size()));
  }

  /** Level of a digital output; null if it is none. */
  synchronized Boolean level(int pin) {
    return levels.get(pin);
  }

  /** What the device at a transmit pin was sent so far. */
  synchronized byte[] received(int pin) {
    ByteArrayOutputStream all = toDevice.get(pin);
    return all == null ? new byte[0] : all.toByteArray();
  }
}
