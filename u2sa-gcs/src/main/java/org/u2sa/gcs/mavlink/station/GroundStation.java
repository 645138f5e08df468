package org.u2sa.gcs.mavlink.station;

import io.dronefleet.mavlink.common.MavSeverity;

/** A ground station at the other end of a link. */
public interface GroundStation {
  /** Sender of a message. */
  record Sender(int system, int component) {}

  /** Component ID of an autopilot, which the vehicle uses in its answers. */
  int AUTOPILOT = 1;

  /** Sends a message; it is lost if the link is full. */
  void send(Object message);

  /** Shows a text to the operator. */
  void text(MavSeverity severity, String text);

  /** Whether the link has room for telemetry and bulk messages. */
  boolean hasRoom();
}
