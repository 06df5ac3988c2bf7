/**
 * Of a form that was refused the first field at fault has the focus, in whatever kind of field it is; not where somebody
 * was faster, and types already.
 */
const fault = document.querySelector('main [aria-invalid="true"]');
const field = fault?.matches('fieldset') ? fault.querySelector('input, select, textarea') : fault;
for (let around = field?.closest('details'); around; around = around.parentElement.closest('details')) {
  around.open = true;
}
if (document.activeElement === document.body || document.activeElement?.autofocus) {
  field?.focus();
}
