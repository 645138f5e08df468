package org.u2sa.messages.contract;

/** Action of a {@link ServiceOrder}. Names are part of the wire format; append only. */
public enum ServiceAction {
  /** Start the service, which must not be running. */
  START,
  /** End the service, regardless of its state, and start it again. */
  RESTART,
  /** Replace the running service with another class, which takes over its state. */
  SWAP
}
