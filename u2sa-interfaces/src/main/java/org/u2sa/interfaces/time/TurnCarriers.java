package org.u2sa.interfaces.time;

import java.util.ArrayDeque;

/**
 * The threads on which a {@link LockstepClock} takes the turns that others lent it. One does, as a
 * rule; further ones are made while code in a lent turn waits for another turn or hangs. They end
 * when nobody lends turns any more. Belongs to whoever holds the clock's lock.
 */
final class TurnCarriers {
  private final ArrayDeque<Carrier> free = new ArrayDeque<>(); // the last to be released is first
  private int lenders;
  private int made;

  /** A thread begins to lend turns. */
  void join() {
    lenders++;
  }

  /** One that joined lends no more. */
  void leave() {
    lenders--;
    if (lenders == 0) {
      free.forEach(Carrier::end);
      free.clear();
    }
  }

  /** Has a carrier take a lent turn. */
  void carry(Loan loan) {
    Carrier carrier = free.poll();
    if (carrier == null) {
      made++;
      carrier = new Carrier("u2sa-turns-" + made);
      carrier.start();
    }
    loan.carriedBy(carrier);
    carrier.carry(loan);
  }

  /** Takes note that the carrier of a loan is free for the next turn. */
  void release(Loan loan) {
    Carrier carrier = loan.carrier();
    loan.carriedBy(null);
    carrier.await();
    if (lenders == 0) {
      carrier.end();
    } else {
      free.push(carrier);
    }
  }

  /** One thread that takes lent turns. */
  static final class Carrier extends Thread {
    private final TurnWait wait = new TurnWait();
    private Loan loan; // null while it waits, and at the end

    private Carrier(String name) {
      super(name);
      setDaemon(false); // nor are the threads that a turn starts, whoever happened to make this one
      wait.begin();
    }

    /** Whose turn it takes; itself if nobody's. Called on this thread. */
    Thread lender() {
      return loan == null ? this : loan.lender();
    }

    private void carry(Loan next) {
      loan = next;
      wait.end();
    }

    private void await() {
      loan = null;
      wait.begin();
    }

    private void end() {
      wait.end();
    }

    @Override
    public void run() {
      for (Loan next = next(); next != null; next = next()) {
        setContextClassLoader(next.lender().getContextClassLoader());
        next.carry();
      }
    }

    private Loan next() {
      while (wait.isWaiting()) {
        wait.await();
        Thread.interrupted(); // of nobody's turn
      }
      return loan;
    }
  }
}
