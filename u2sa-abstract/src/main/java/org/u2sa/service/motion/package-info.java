/**
 * Properties of a vehicle's motion that services of several roles need besides its estimated state.
 * Estimating the state itself belongs to org.u2sa.estimation.
 */
package org.u2sa.service.motion;
