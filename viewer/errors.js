// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records the errors of the page in window.cscd.errors. It runs first.

window.cscd = { errors: [] };
window.addEventListener('error', (event) => window.cscd.errors.push(String(event.message)));
document.addEventListener('securitypolicyviolation', (event) =>
  window.cscd.errors.push(`refused by the content security policy: ${event.blockedURI}`),
);
for (const level of ['error', 'warn']) {
  const print = console[level];
  console[level] = (...values) => {
    window.cscd.errors.push(values.join(' '));
    print.apply(console, values);
  };
}
