package org.u2sa.messages.contract;

/** What a {@link ServiceOrder} asks for. The names travel; append only. */
public enum ServiceAction {
  /** Start it; it does not run. */
  START,
  /** End it, whatever state it is in, and start it anew. */
  RESTART,
  /** Put another class in its place while it runs; the new one takes its state over. */
  SWAP
}
