package org.u2sa.messages.safety;

/** Operator's order about the geofence. The order is part of the wire format. */
public enum FenceAction {
  /** Replace the fence in force. */
  REPLACE,
  /** Remove the fence; the vehicle may go anywhere. */
  REMOVE,
  /** Return to the fence of the file named by the Safety Manager's variable FENCE. */
  RELOAD
}
