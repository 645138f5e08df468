/**
 * Error-state Kalman filter of the fusing State Estimator: models, update, history, trust in
 * sources. Services do not belong here; the code is independent of channels and clocks.
 */
package org.u2sa.estimation.fusion;
