package org.u2sa.sim.ioio;

import java.io.ByteArrayOutputStream;
import java.util.Map;
import java.util.TreeMap;

/** A bench with a board on it: writes down what the pins give, and gives what a test sets. */
final class Bench implements Pins {
  final Map<Integer, PulseTrain> driven = new TreeMap<>();
  final Map<Integer, Boolean> levels = new TreeMap<>();
  final Map<Integer, ByteArrayOutputStream> sent = new TreeMap<>();
  final Map<Integer, Double> volts = new TreeMap<>();
  final Map<Integer, PulseTrain> pulses = new TreeMap<>();
  final Map<Integer, Boolean> inputs = new TreeMap<>();
  byte[] device = new byte[0]; // bytes of the device, taken by one call
  int baud;

  final IoioFirmware firmware = new IoioFirmware(IoioBoard.OTG, this);
  private long nowMicros;

  Bench() {
    firmware.advance(0);
  }

  @Override
  public void driven(int pin, PulseTrain train) {
    levels.remove(pin);
    driven.put(pin, train);
  }

  @Override
  public void driven(int pin, boolean high) {
    driven.remove(pin);
    levels.put(pin, high);
  }

  @Override
  public void released(int pin) {
    driven.remove(pin);
    levels.remove(pin);
  }

  @Override
  public void transmitted(int pin, int rate, byte[] bytes, int length) {
    baud = rate;
    sent.computeIfAbsent(pin, any -> new ByteArrayOutputStream()).write(bytes, 0, length);
  }

  @Override
  public int received(int pin, int rate, byte[] buffer) {
    int count = device.length;
    System.arraycopy(device, 0, buffer, 0, count);
    device = new byte[0];
    return count;
  }

  @Override
  public double volts(int pin) {
    return volts.getOrDefault(pin, 0.0);
  }

  @Override
  public PulseTrain pulses(int pin) {
    return pulses.getOrDefault(pin, PulseTrain.NONE);
  }

  @Override
  public boolean high(int pin) {
    return inputs.getOrDefault(pin, false);
  }

  /** A board with an open connection whose greeting was taken. */
  Bench open() {
    firmware.open();
    answer();
    return this;
  }

  Bench send(int... octets) {
    byte[] bytes = new byte[octets.length];
    for (int i = 0; i < octets.length; i++) {
      bytes[i] = (byte) octets[i];
    }
    firmware.accept(bytes, 0, bytes.length);
    return this;
  }

  Bench advance(double seconds) {
    nowMicros += Math.round(seconds * 1.0e6);
    firmware.advance(nowMicros);
    return this;
  }

  /** All that the board has said since the last call, as hexadecimal digits. */
  String answer() {
    StringBuilder text = new StringBuilder();
    byte[] buffer = new byte[64];
    for (int count = firmware.output(buffer); count > 0; count = firmware.output(buffer)) {
      for (int i = 0; i < count; i++) {
        text.append(text.length() == 0 ? "" : " ").append(String.format("%02x", buffer[i]));
      }
    }
    return text.toString();
  }
}
