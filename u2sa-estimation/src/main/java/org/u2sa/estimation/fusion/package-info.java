/**
 * The error-state Kalman filter beneath the fusing State Estimator: model, update, history, trust
 * in sources. Services do not belong here; nothing in it knows a channel or a clock.
 */
package org.u2sa.estimation.fusion;
