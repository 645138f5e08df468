package org.u2sa.drivers.motor;

import org.u2sa.drivers.link.MemoryLink;

/**
 * A Maestro servo controller, byte for byte, written apart from the driver: targets in quarters of
 * a microsecond, 0 for no pulses, as after power-up.
 */
final class SimulatedMaestro {
  private final int[] targets = new int[24];
  private final MemoryLink link;

  SimulatedMaestro(MemoryLink link) {
    this.link = link;
    link.with(this::accept);
  }

  /** Pulse at a channel [µs]. */
  double pulseUs(int channel) {
    return targets[channel] / 4.0;
  }

  private void accept(byte[] bytes) {
    int channel = bytes[1];
    switch (bytes[0] & 0xFF) {
      case 0x84 -> targets[channel] = bytes[2] + 128 * bytes[3];
      case 0x90 ->
          link.fromDevice((byte) (targets[channel] % 256), (byte) (targets[channel] / 256));
      default -> throw new AssertionError("unknown command");
    }
  }
}
