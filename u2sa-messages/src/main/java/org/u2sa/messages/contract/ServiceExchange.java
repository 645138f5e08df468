package org.u2sa.messages.contract;

/**
 * A request to one service, or its answer, linked by the request ID.
 *
 * @param <S> the subclass, returned by setters
 */
public abstract class ServiceExchange<S extends ServiceExchange<S>> extends ServiceMessage<S> {
  static final String REQUEST_ID = "requestId";

  /** Unique ID that links an answer to its request; chosen by the sender of the request. */
  public final String requestId() {
    return required(REQUEST_ID);
  }

  public final S requestId(String value) {
    return set(REQUEST_ID, value);
  }
}
