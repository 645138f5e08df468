/**
 * What services of several roles must know of a vehicle's motion besides its estimated state.
 * Estimating the state itself belongs to org.u2sa.estimation.
 */
package org.u2sa.service.motion;
