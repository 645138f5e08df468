package org.u2sa.interfaces.time;

import java.util.ArrayDeque;

/**
 * Worker threads on which a {@link LockstepClock} runs lent turns: usually one, more while a turn
 * waits inside or hangs. They end when no thread lends turns. Guarded by the clock's lock.
 */
final class LentTurnThreads {
  private final ArrayDeque<Carrier> free = new ArrayDeque<>(); // LIFO
  private int lenders;
  private int made;

  void join() {
    lenders++;
  }

  void leave() {
    lenders--;
    if (lenders == 0) {
      free.forEach(Carrier::end);
      free.clear();
    }
  }

  void carry(LentTurns loan) {
    Carrier carrier = free.poll();
    if (carrier == null) {
      made++;
      carrier = new Carrier("u2sa-turns-" + made);
      carrier.start();
    }
    loan.carriedBy(carrier);
    carrier.carry(loan);
  }

  void release(LentTurns loan) {
    Carrier carrier = loan.carrier();
    loan.carriedBy(null);
    carrier.await();
    if (lenders == 0) {
      carrier.end();
    } else {
      free.push(carrier);
    }
  }

  static final class Carrier extends Thread implements TurnThread {
    private final TurnWait wait = new TurnWait();
    private LentTurns loan; // null while idle, and at the end

    private Carrier(String name) {
      super(name);
      setDaemon(false); // inherited by threads that a turn starts
      wait.begin();
    }

    @Override
    public Thread lender() {
      return loan == null ? this : loan.lender();
    }

    private void carry(LentTurns next) {
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
      for (LentTurns next = next(); next != null; next = next()) {
        setContextClassLoader(next.lender().getContextClassLoader());
        next.carry();
      }
    }

    private LentTurns next() {
      while (wait.isWaiting()) {
        wait.await();
        Thread.interrupted(); // belongs to no turn
      }
      return loan;
    }
  }
}
