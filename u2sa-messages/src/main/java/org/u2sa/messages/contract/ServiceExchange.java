package org.u2sa.messages.contract;

/**
 * A request to one service or its answer, which have the request's ID in common.
 *
 * @param <S> the subclass, which setters return
 */
public abstract class ServiceExchange<S extends ServiceExchange<S>> extends ServiceMessage<S> {
  static final String REQUEST_ID = "requestId";

  /** Tells which request an answer is for; chosen by the sender of the request, unique. */
  public final String requestId() {
    return required(REQUEST_ID);
  }

  /** Sets {@link #requestId()}. */
  public final S requestId(String value) {
    return set(REQUEST_ID, value);
  }
}
