/**
 * Who may do what over the network: users, their passwords and roles, and the files that hold them.
 * How a broker enforces it does not belong here.
 */
package org.u2sa.core.security;
