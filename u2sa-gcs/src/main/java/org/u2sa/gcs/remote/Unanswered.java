package org.u2sa.gcs.remote;

/** Remarks on orders without an answer: a broker or connection may still deliver them. */
public final class Unanswered {
  /** On an order that services obey only within ORDER EXPIRY. */
  public static final String EXPIRING =
      "the order may still be carried out if it is delivered within ORDER EXPIRY (5 s by default)";

  /** On an order that counts whenever it arrives, such as to disarm. */
  public static final String LASTING =
      "the order may still be carried out, whenever it is delivered";

  private Unanswered() {}
}
